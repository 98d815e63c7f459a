namespace Nowpose.Cli.Calibrate.Simulate;

/// <summary>The true times of a simulated picture.</summary>
/// <param name="Middle">Control time at the middle of the exposure, for the row of the headset's code.</param>
/// <param name="ExposureMs">Exposure time, ms.</param>
/// <param name="Frame">Index of the frame that is lit at that time.</param>
readonly record struct SimulatedMoment(ControlTime Middle, double ExposureMs, int Frame);
