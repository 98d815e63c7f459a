using System.CommandLine;
using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate;

/// <summary><c>--profile</c>: ways that find L_visu alone keep the limit of the render time that another way has found.</summary>
/// <remarks>Without one it still knows which headset is measured.</remarks>
sealed class EarlierProfile
{
    readonly LatencyProfile _profile;

    EarlierProfile(LatencyProfile profile, string device, double displayHz)
    {
        _profile = profile;
        Device = profile != null && device.Length == 0 ? profile.Device : device;
        DisplayHz = profile != null && displayHz == 0 ? profile.DisplayHz : displayHz;
    }

    /// <summary>The headset's model; empty where nobody says it.</summary>
    public string Device { get; }

    /// <summary>0 where nobody says it.</summary>
    public double DisplayHz { get; }

    public static Option<string> Option() => new("--profile")
    {
        Description = "An earlier profile of the same device, whose limit of the render time is kept",
    };

    /// <summary>To be called before the measuring, so that a profile that cannot be used costs no more than a line.</summary>
    /// <param name="path">Null for none.</param>
    /// <param name="device">Null for the sweep's, as <paramref name="displayHz"/>.</param>
    /// <param name="sweep">Null for none.</param>
    /// <exception cref="InputException">It is none that can be read, or of another device or display rate.</exception>
    public static EarlierProfile Read(string path, string device, double? displayHz, IReadOnlyList<SweepRow> sweep = null)
    {
        device ??= sweep == null ? "" : SweepTable.Device(sweep);
        var rate = displayHz ?? (sweep == null ? 0 : SweepTable.DisplayHz(sweep));
        var profile = path == null ? null : LatencyProfileFile.Load(path);
        if (profile?.RefusalFor(device, rate) is string refusal) throw new InputException($"--profile: {path}: {refusal}");
        return new EarlierProfile(profile, device, rate);
    }

    /// <summary>The profile with another L_visu.</summary>
    public LatencyProfile With(double visuMs, double spreadMs, CalibrationMethod method, int measurements) => new(
        visuMs, spreadMs, Device, DisplayHz, DateTime.UtcNow, method, measurements, _profile?.Range?.Limit.TotalMilliseconds,
        _profile?.RenderTimeSource ?? RenderTimeSourceKind.None, _profile?.ValidToRenderTime?.TotalMilliseconds);
}
