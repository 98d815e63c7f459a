namespace Nowpose.Cli.Calibrate.Simulate;

/// <summary>The true values of a picture.</summary>
/// <param name="Middle">Control time at the middle of the exposure, at the height of the headset's code.</param>
/// <param name="ExposureMs">Length of the exposure, ms.</param>
/// <param name="Frame">Index of the frame that is lit at that time.</param>
readonly record struct SimulatedMoment(ControlTime Middle, double ExposureMs, int Frame);
