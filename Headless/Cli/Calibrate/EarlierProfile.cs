using System.CommandLine;
using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate;

/// <summary><c>--profile</c>: ways that find L_visu alone keep the limit of the render time that another way has found.</summary>
static class EarlierProfile
{
    public static Option<string> Option() => new("--profile")
    {
        Description = "An earlier profile of the same device, whose limit of the render time is kept",
    };

    /// <param name="earlierPath">Null for none.</param>
    /// <param name="device">Empty, and <paramref name="displayHz"/> 0, for the earlier profile's.</param>
    public static LatencyProfile With(
        string earlierPath, double visuMs, double spreadMs, string device, double displayHz, CalibrationMethod method, int measurements)
    {
        var earlier = earlierPath == null ? null : LatencyProfileFile.Load(earlierPath);
        if (earlier?.RefusalFor(device, displayHz) is string refusal) throw new InputException($"--profile: {earlierPath}: {refusal}");
        if (earlier != null && device.Length == 0) device = earlier.Device;
        if (earlier != null && displayHz == 0) displayHz = earlier.DisplayHz;
        return new LatencyProfile(
            visuMs, spreadMs, device, displayHz, DateTime.UtcNow, method, measurements, earlier?.Range?.Limit.TotalMilliseconds,
            earlier?.RenderTimeSource ?? RenderTimeSourceKind.None, earlier?.ValidToRenderTime?.TotalMilliseconds);
    }
}
