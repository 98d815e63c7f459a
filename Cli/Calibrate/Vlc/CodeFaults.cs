using Nowpose.Latency;
using Nowpose.Vision;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Finds the reason why a picture does not contain exactly one complete code of each kind.</summary>
static class CodeFaults
{
    /// <summary>A code is rejected if it extends beyond the picture by at least this share of its side: half a cell.</summary>
    const double MinOutside = 0.5 / TimestampCode.Side;

    /// <returns>The reason; null if there is exactly one code of each kind, both inside the picture.</returns>
    public static string Of(SeenPicture seen)
    {
        if (seen.IsMirrored) return PictureFaults.Mirrored;
        var (controls, headsets) = (seen.CodesOf(CodeKind.Control), seen.CodesOf(CodeKind.Headset));
        if (controls.Count > 1) return PictureFaults.ControlCodes(Words(controls.Count));
        if (headsets.Count > 1) return PictureFaults.HeadsetCodes(Words(headsets.Count));
        if (seen.Codes.Count == 0) return PictureFaults.NoCode;
        if (controls.Count == 0) return PictureFaults.NoControlCode;
        if (headsets.Count == 0) return PictureFaults.NoHeadsetCode;
        if (IsCutOff(controls[0], seen)) return PictureFaults.ControlCodeCutOff;
        return IsCutOff(headsets[0], seen) ? PictureFaults.HeadsetCodeCutOff : null;
    }

    static bool IsCutOff(FoundCode code, SeenPicture seen)
    {
        var outside = MinOutside * code.Side;
        return code.Corners.Any(corner => corner.X < -outside || corner.Y < -outside || corner.X > seen.Width + outside || corner.Y > seen.Height + outside);
    }

    static string Words(int count) => count == 2 ? "two" : $"{count}";
}
