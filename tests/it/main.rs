//! Integration tests, one module for each subject.
//!
//! The modules form a single program, which links the library and the shared code only once. Tests that count
//! allocations are in `tests/alloc`.

#![allow(
    clippy::unwrap_used,
    clippy::float_cmp,
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "tests panic on failure, compare exact results, and use small counts"
)]

mod adaptive_contacts;
mod bulk_strain;
mod cancelled_calls;
mod cancelled_solves;
mod centre_values;
mod certificate_formulas;
mod closed_form_validation;
mod closed_forms;
mod closed_forms_cone_punch_waves;
mod coated_bodies;
mod coated_stresses;
mod contact_conditions;
#[cfg(feature = "dense")]
mod contact_edges;
mod contact_reference_data;
mod contact_reference_histories;
mod contact_reference_normal;
mod contact_reference_tangential;
mod contact_spots;
mod contact_stiffness;
#[cfg(feature = "dense")]
mod convolution_equals_direct_sum;
mod coupled_contact;
mod coupled_histories;
mod coupled_projection_reference;
mod coupled_rolling;
mod coupled_termination;
mod csv_labels;
mod custom_operators;
#[cfg(feature = "serde")]
mod cycle_restart;
mod cycle_sums;
mod debug_output;
mod distributed_io;
mod distributed_io_is_atomic;
mod engine_exact_minimum;
mod equality;
mod extreme_inputs;
mod file_formats;
mod file_round_trip;
mod fretting_loops;
mod frozen_scenes;
mod gaussian_filters;
mod glued_cells;
#[cfg(feature = "dense")]
mod grid_error_estimate;
mod growing_contact_step_size;
#[cfg(feature = "dense")]
mod hard_cases;
mod hardness;
mod height_moments;
mod hertz_and_cattaneo_mindlin;
mod history_coatings;
mod history_continuation_is_bitwise;
mod history_energy_balance;
mod history_failed_steps;
mod history_hardness;
mod history_laws;
mod history_mindlin_deresiewicz;
mod history_restart;
mod history_springs;
mod history_states;
mod history_stick_edges;
mod history_vector_model;
mod history_wear;
mod influence_coefficients;
mod input_validation;
mod jaeger_superposition;
mod levelling;
mod load_paths;
mod load_validation;
#[cfg(feature = "dense")]
mod matrix_validation;
mod messages;
mod method_agreement;
mod mixed_solutions;
mod moments_and_energies;
mod near_gross_slip;
mod nested_start_accuracy;
mod next_step_stiffness;
mod one_way_coupling;
mod outdated_results;
mod outdated_solutions;
mod oversized_inputs;
mod periodic_contact;
mod plane_strain_lines;
mod problem_laws;
#[cfg(feature = "dense")]
mod random_scenes;
mod rank_contacts;
mod rank_coupled_contacts;
mod rank_exchange;
mod rank_failures;
mod rank_histories;
mod rank_input_consistency;
mod rank_stresses;
mod rank_surfaces;
mod rolling_closed_forms;
mod rolling_histories;
mod rolling_lines;
mod rolling_loads;
mod rolling_moments;
mod rolling_slip_direction;
mod rolling_under_changing_loads;
mod rough_contacts;
mod rough_surface_refinement;
mod rough_surfaces;
mod saved_files;
mod scene_laws;
mod sensitivities;
#[cfg(feature = "serde")]
mod serialisation;
mod sheared_history_stiffness;
mod sign_conventions;
mod solve_limits;
mod solver_setters;
mod solver_settings;
mod special_states;
mod start_independence;
mod statistics_invariances;
mod statistics_reference;
mod steady_rolling;
mod stepwise_pressing;
mod study_restart;
mod subsurface_blocks;
mod subsurface_planes;
mod subsurface_points;
mod surface_preparation;
mod surface_shapes;
mod surface_validation;
mod thread_determinism;
mod unchanged_problems;
mod user_kernels;
mod user_operators;
mod values_without_effect;
mod vector_model;
mod vector_springs;
mod warm_starts;
mod warnings;
mod wear_laws;
mod window_shrinking;
mod worn_gaps;
