using Nowpose.Latency;
using Nowpose.Vision;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Finds the reason why a picture does not contain exactly one complete code of each kind.</summary>
static class CodeFaults
{
    /// <summary>Minimum length by which a code is outside the picture to be rejected, as a share of its side: half a cell.</summary>
    const double MinOutside = 0.5 / TimestampCode.Side;

    /// <returns>The reason; null if there is exactly one code of each kind, both inside the picture.</returns>
    public static string Of(SeenPicture seen)
    {
        if (seen.IsMirrored) return "mirrored: switch off mirroring in the camera's settings";
        var (controls, headsets) = (seen.CodesOf(CodeKind.Control), seen.CodesOf(CodeKind.Headset));
        if (controls.Count > 1) return $"{Words(controls.Count)} control codes: show one only";
        if (headsets.Count > 1) return $"{Words(headsets.Count)} headset codes: show one only";
        if (seen.Codes.Count == 0) return "no code found";
        if (controls.Count == 0) return "no control code found";
        if (headsets.Count == 0) return "no headset code found";
        if (IsCutOff(controls[0], seen)) return "control code partly outside the picture";
        return IsCutOff(headsets[0], seen) ? "headset code partly outside the picture" : null;
    }

    static bool IsCutOff(FoundCode code, SeenPicture seen)
    {
        var outside = MinOutside * code.Side;
        return code.Corners.Any(corner => corner.X < -outside || corner.Y < -outside || corner.X > seen.Width + outside || corner.Y > seen.Height + outside);
    }

    static string Words(int count) => count == 2 ? "two" : $"{count}";
}
