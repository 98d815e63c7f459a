using Nowpose.VisibleLight;
using Nowpose.Vision;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>From the codes found in a picture to L_visu, Eq. (7).</summary>
/// <param name="ReadoutMs">How much later a rolling shutter exposes the last row than the first, ms.</param>
/// <param name="ControlDelayMs">By how much a monitor that shows the control code is late, ms; 0 for LEDs, which change every millisecond.</param>
sealed record PictureReader(double ReadoutMs, double ControlDelayMs)
{
    /// <summary>What L_visu can be, ms: beyond it a code was misread, or the clocks are not synchronised.</summary>
    const double Least = -50, Greatest = 500;

    public PictureResult Read(string file, SeenPicture seen)
    {
        if (seen.Fault != null) return PictureResult.Not(file, $"unreadable: {seen.Fault}");
        var (control, headset) = (seen.CodeOf(CodeKind.Control), seen.CodeOf(CodeKind.Headset));
        if (control == null || headset == null)
            return PictureResult.Not(file, control == headset ? "no code found" : control == null ? "no control code found" : "no headset code found");
        var shown = HeadsetCode.Read(new CodeContrasts(headset));
        if (shown.Fault != null) return PictureResult.Not(file, $"headset code {shown.Fault}");
        var contrasts = new CodeContrasts(control);
        // A monitor shows a code for a frame, as the headset does, but any code may follow.
        var lit = ControlDelayMs > 0 ? HeadsetCode.Read(contrasts, leastStep: 1) : ControlCode.Read(contrasts, DelaysOf(control, seen.Height));
        if (lit.Fault != null) return PictureResult.Not(file, $"control code {lit.Fault}");
        // At the moment at which the headset's rows were exposed.
        var later = ReadoutMs * (MiddleOf(headset) - MiddleOf(control)) / seen.Height;
        var led = Wrapped(lit.Ms + ControlDelayMs + later);
        var visu = Wrapped(led - shown.Ms + TimestampCode.PeriodMs / 2) - TimestampCode.PeriodMs / 2;
        return visu is >= Least and <= Greatest
            ? new PictureResult(file, led, shown.Ms, visu, null)
            : PictureResult.Not(file, FormattableString.Invariant($"codes more than {Greatest} ms apart"));
    }

    double[] DelaysOf(FoundCode code, int height)
    {
        var middle = MiddleOf(code);
        var delays = new double[TimestampCode.PairCount];
        for (var pair = 0; pair < delays.Length; pair++)
        {
            var cell = TimestampCode.CellOf(pair);
            delays[pair] = ReadoutMs * (code.HeightOf(cell % TimestampCode.Side + 1, cell / TimestampCode.Side + 0.5) - middle) / height;
        }
        return delays;
    }

    static double MiddleOf(FoundCode code) => code.HeightOf(TimestampCode.Side / 2.0, TimestampCode.Side / 2.0);

    static double Wrapped(double ms) => ms - TimestampCode.PeriodMs * Math.Floor(ms / TimestampCode.PeriodMs);
}
