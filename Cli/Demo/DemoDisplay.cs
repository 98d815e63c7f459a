using Nowpose.Simulation;

namespace Nowpose.Cli.Demo;

/// <summary>The simulated headset's display: when frames start, and when their light is seen.</summary>
/// <remarks>Without vertices to render: 60 frames a second, constant L_visu and no render times. Allocates no memory after construction.</remarks>
sealed class DemoDisplay
{
    public const int FramesPerSecond = 60;

    /// <summary>Number of stored frames. At most two are in progress, so one of them is always finished.</summary>
    const int Remembered = 4;

    readonly DisplayPipeline _pipeline;
    readonly Func<TimeSpan, double> _verticesAt;
    readonly TimeSpan _visualisation;
    readonly PipelineFrame[] _newest = new PipelineFrame[Remembered];
    long _frames;

    public DemoDisplay(DemoSettings settings)
    {
        _visualisation = TimeSpan.FromMilliseconds(settings.VisualisationMs);
        if (!settings.IsRendered) return;
        _verticesAt = settings.Load is int vertices
            ? new DemoLoad(vertices, settings.Seconds).VerticesAt : _ => settings.SteadyVertices.Value;
        _pipeline = new DisplayPipeline(settings.Seed, Settings(settings));
    }

    /// <summary>Start of the next frame, since the run began.</summary>
    public TimeSpan NextStart => _pipeline?.NextStart ?? TimeSpan.FromSeconds((double)_frames / FramesPerSecond);

    /// <summary>True L_visu of the newest frame.</summary>
    public TimeSpan Visualisation => Rendered?.Visualisation ?? _visualisation;

    /// <summary>The newest frame's timing in the pipeline; null without vertices to render.</summary>
    public PipelineFrame? Rendered => _pipeline == null || _frames == 0 ? null : _newest[(_frames - 1) % Remembered];

    /// <summary>The driver's render time at the start of the newest frame: that of the last finished frame. Null if there is none.</summary>
    public TimeSpan? DriverTime
    {
        get
        {
            if (_pipeline == null) return null;
            for (var back = 2; back <= Remembered && back <= _frames; back++)
            {
                var frame = _newest[(_frames - back) % Remembered];
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
        if (_pipeline != null) _newest[_frames % Remembered] = _pipeline.Next(_verticesAt(_pipeline.NextStart));
        _frames++;
    }
}
