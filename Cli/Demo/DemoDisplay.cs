using Nowpose.Simulation;

namespace Nowpose.Cli.Demo;

/// <summary>Simulates the headset's display: the start and the display time of each frame.</summary>
/// <remarks>
/// Without vertices to render, it has 60 frames per second, a constant L_visu and no render times. Allocates only in its constructor.
/// </remarks>
sealed class DemoDisplay
{
    public const int FramesPerSecond = 60;

    /// <summary>
    /// Number of stored frames. With at most two frames in progress, at least one finished frame before the newest is always stored.
    /// </summary>
    const int Stored = 4;

    readonly DisplayPipeline _pipeline;
    readonly Func<TimeSpan, double> _verticesAt;
    readonly TimeSpan _visualisation;
    readonly PipelineFrame[] _newest = new PipelineFrame[Stored];
    long _frames;

    public DemoDisplay(DemoSettings settings)
    {
        _visualisation = TimeSpan.FromMilliseconds(settings.VisualisationMs);
        if (!settings.IsRendered) return;
        _verticesAt = settings.Load is int vertices
            ? new DemoLoad(vertices, settings.Seconds).VerticesAt : _ => settings.SteadyVertices.Value;
        _pipeline = new DisplayPipeline(settings.Seed, Settings(settings));
    }

    /// <summary>Start of the next frame, relative to the start of the run.</summary>
    public TimeSpan NextStart => _pipeline?.NextStart ?? TimeSpan.FromSeconds((double)_frames / FramesPerSecond);

    /// <summary>True L_visu of the newest frame.</summary>
    public TimeSpan Visualisation => Rendered?.Visualisation ?? _visualisation;

    /// <summary>Timing of the newest frame in the pipeline; null without vertices to render.</summary>
    public PipelineFrame? Rendered => _pipeline == null || _frames == 0 ? null : _newest[(_frames - 1) % Stored];

    /// <summary>Render time that the driver reports when the newest frame starts: that of the last finished frame; null if there is none.</summary>
    public TimeSpan? DriverTime
    {
        get
        {
            if (_pipeline == null) return null;
            for (var back = 2; back <= Stored && back <= _frames; back++)
            {
                var frame = _newest[(_frames - back) % Stored];
                if (frame.Done <= Rendered.Value.Start) return frame.RenderTime;
            }
            return null;
        }
    }

    /// <summary>Gets the pipeline settings of a run.</summary>
    public static DisplayPipelineSettings Settings(DemoSettings settings) => new(settings.RefreshMs, plateauMs: settings.VisualisationMs);

    /// <summary>Renders the next frame.</summary>
    public void Render()
    {
        if (_pipeline != null) _newest[_frames % Stored] = _pipeline.Next(_verticesAt(_pipeline.NextStart));
        _frames++;
    }
}
