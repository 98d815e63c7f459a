/** Keys of a headset's diagnostics that the page reads. A C# test compares them with the list of the headset, `HeadsetKeys.cs`. */
export type HeadsetKey =
  | 'state'
  | 'error_bound_us'
  | 'estimated_error_us'
  | 'rtt_ms'
  | 'pose'
  | 'current_share'
  | 'missing_joints'
  | 'objects_not_current'
  | 'signals_not_current'
  | `object_status/${string}`
  | `signal_status/${string}`
  | 'samples'
  | 'dropped'
  | 'l_app_ms'
  | 'l_visu_ms'
  | 'render_ms'
  | 'range'
  | 'profile_mismatch'
  | 'error_withheld'
  | 'error_mm'
  | 'error_mm_hold'
  | 'reduction';
