using System.CommandLine;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Options;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;

namespace Nowpose.Cli.Calibrate;

/// <summary>Options for the conditions of a measurement that its files do not contain: device, display rate and others.</summary>
sealed class DeviceOptions
{
    readonly Dictionary<DisplayCondition, Option<string>> _texts = new()
    {
        [DisplayCondition.Device] = TextOption.Create(
            "--device", "Model of the headset, as in Unity's SystemInfo.deviceModel and the sweep's log. The headset refuses a profile of another "
                + "model. Default: the model in the sweep's log; without a log, the profile is valid for any model"),
        [DisplayCondition.GraphicsApi] = Text("--graphics-api", "Graphics API as named by SystemInfo.graphicsDeviceType, for example Direct3D11"),
        [DisplayCondition.GraphicsJobs] = Text(
            "--graphics-jobs", "Rendering threads, as SystemInfo.renderingThreadingMode names them: MultiThreaded without Graphics Jobs"),
        [DisplayCondition.RenderPipeline] = Text("--render-pipeline", "Type name of the render pipeline's asset, or built-in"),
        [DisplayCondition.RewriteBeforeRender] = Choice(
            "--rewrite-before-render", "Whether the pose is computed a second time right before rendering",
            [DisplayConditions.On, DisplayConditions.Off]),
        [DisplayCondition.LatencyOptimization] = Text(
            "--latency-optimization", "OpenXR's Latency Optimization: PrioritizeRendering or PrioritizeInputPolling"),
        [DisplayCondition.Reprojection] = Choice(
            "--reprojection", "How the display corrects frames for head motion",
            [.. Enum.GetValues<ReprojectionMode>().Select(LatencyNames.Reprojection.NameOf)]),
    };

    readonly Option<double> _displayHz = NumberOption.Create(
        "--display-hz", "Refresh rate of the headset's display; 0: the rate in the sweep's log; without a log, the profile is valid for any rate",
        0.0, 0, 1000, "Hz");

    public void AddTo(Command verb)
    {
        foreach (var option in _texts.Values) verb.Options.Add(option);
        verb.Options.Add(_displayHz);
    }

    /// <summary>Gets the conditions that were given as options. The other conditions stay unknown.</summary>
    /// <exception cref="InputException">A value is invalid.</exception>
    public DisplayConditions Conditions(ParseResult parsed) => DisplayConditions.Parse(
            condition => _texts.TryGetValue(condition, out var option) ? parsed.GetValue(option) : null)
        .Or(new DisplayConditions(displayHz: parsed.GetValue(_displayHz)));

    /// <summary>Creates the option for the source of the render time, used by methods that find a render time limit.</summary>
    public static Option<string> Source() => ChoiceOption.Create(
        "--source", "Source of render_ms; the limit is valid for this source only",
        LatencyNames.RenderTimeSource.NameOf(RenderTimeSourceKind.DisplayGpuTime),
        [.. Enum.GetValues<RenderTimeSourceKind>().Where(kind => kind != RenderTimeSourceKind.None).Select(LatencyNames.RenderTimeSource.NameOf)]);

    /// <param name="source">One of the values that <see cref="Source"/> allows.</param>
    public static RenderTimeSourceKind KindOf(string source) =>
        LatencyNames.RenderTimeSource.TryParse(source, out var kind)
            ? kind : throw new InputException(OptionMessages.UnknownChoice("--source", source, LatencyNames.RenderTimeSource.All));

    static Option<string> Text(string name, string description) => TextOption.Create(name, description + "; same default as --device");

    static Option<string> Choice(string name, string description, string[] allowed) =>
        ChoiceOption.Create(name, description + "; same default as --device", null, allowed);
}
