namespace Nowpose.Cli.Calibrate.Simulate;

/// <summary>What is true of a picture.</summary>
/// <param name="Middle">Control time in the middle of the exposure, at the height of the headset's code.</param>
/// <param name="ExposureMs">How long it is.</param>
/// <param name="Frame">Which frame is in the light then.</param>
readonly record struct SimulatedMoment(ControlTime Middle, double ExposureMs, int Frame);
