using Nowpose.Latency;
using Nowpose.Latency.Calibration;

namespace Nowpose.Cli.Calibrate;

/// <summary>The offsets at which hologram and robot coincided by eye.</summary>
sealed record NudgeMarks(double SpeedMmPerS, double ConfiguredMs, double[] ForwardMm, double[] BackwardMm)
{
    /// <exception cref="InputException">A direction is missing, or a value is out of range.</exception>
    public NudgeResult Result()
    {
        var calibration = new NudgeCalibration(SpeedMmPerS, ConfiguredMs);
        foreach (var offset in ForwardMm) calibration.AddForward(offset);
        foreach (var offset in BackwardMm) calibration.AddBackward(offset);
        return calibration.Result;
    }
}
