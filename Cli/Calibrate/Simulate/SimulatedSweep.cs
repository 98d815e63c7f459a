using Nowpose.Cli.Replay;
using Nowpose.Latency;
using Nowpose.Latency.Sweep;
using Nowpose.Simulation;

namespace Nowpose.Cli.Calibrate.Simulate;

/// <summary>Simulates the frames of a load sweep on a display, and the times at which a camera takes pictures of the display.</summary>
/// <remarks>
/// The camera is not synchronised with the display: the exposure of a picture overlaps the time in which a frame is lit by a random part. No pictures
/// are taken that contain less than half of the possible light of a frame, except for a video with a rate.
/// </remarks>
sealed class SimulatedSweep
{
    /// <summary>Mean number of frames between two pictures, for about 8 pictures per second.</summary>
    const int FramesPerPicture = 7;

    /// <summary>Mean number of frames between two pictures of a video, for 30 pictures per second. A moving headset needs this rate.</summary>
    const int FramesPerVideoPicture = 2;

    /// <summary>Number of frames before the first and after the last picture, so that every picture has neighbouring frames.</summary>
    const int Margin = 12;

    /// <summary>Minimum share of the possible light of a frame in a picture. With less light, the headset's code cannot be read.</summary>
    const double MinLight = 0.5;

    const int OrdinaryVertices = 300_000;

    /// <summary>Refresh interval of a display with a nominal rate of 60 Hz. Its frames begin at any fraction of a millisecond.</summary>
    public const double RefreshMs = 1000 / 59.94;

    /// <summary>Values for the log: device name and nominal rate of the display.</summary>
    const string Device = "simulated headset";
    const double DisplayHz = 60;

    static readonly ControlTime Beginning = ControlTime.FromSeconds(86_400);

    readonly SimulationSettings _settings;
    readonly int _framesPerPicture;
    readonly List<PipelineFrame> _frames = [];

    public SimulatedSweep(SimulationSettings settings)
    {
        _settings = settings;
        _framesPerPicture = settings.HeadLatencyMs.HasValue ? FramesPerVideoPicture : FramesPerPicture;
        var display = settings.Display ?? new DisplayPipelineSettings(refreshMs: RefreshMs, plateauMs: settings.VisuMs);
        var pipeline = new DisplayPipeline(settings.Seed, display);
        var framesPerPicture = 1000 / RefreshMs / settings.PicturesPerSecond ?? _framesPerPicture;
        var frames = (int)Math.Ceiling(settings.Pictures * framesPerPicture) + 2 * Margin;
        var rows = new List<SweepRow>(frames);
        var rendered = new Queue<PipelineFrame>();
        double? renderMs = null;
        for (var i = 0; i < frames; i++)
        {
            var vertices = VerticesOf(i, frames);
            var frame = pipeline.Next(vertices);
            // For each frame, the log contains the render time of the newest frame that the GPU has finished by the start of that frame.
            for (; rendered.TryPeek(out var oldest) && oldest.Done <= frame.Start; rendered.Dequeue()) renderMs = oldest.RenderTime.TotalMilliseconds;
            rendered.Enqueue(frame);
            _frames.Add(frame);
            rows.Add(new SweepRow(StartOf(i), vertices, renderMs, RenderTimeSourceKind.DisplayGpuTime, Device, DisplayHz));
        }
        Rows = rows;
        var random = new RandomStream(settings.Seed, purpose: 1);
        Moments = settings.PicturesPerSecond is double rate
            ? [.. Video(rate, random)]
            : [.. Enumerable.Range(0, settings.Pictures).Select(picture => MomentOf(picture, random))];
    }

    public IReadOnlyList<SweepRow> Rows { get; }

    /// <summary>True values of the pictures, one entry per picture.</summary>
    public IReadOnlyList<SimulatedMoment> Moments { get; }

    public ControlTime StartOf(int frame) => Beginning + _frames[frame].Start;

    /// <summary>Gets the middle of the time in which a frame is lit.</summary>
    public ControlTime LightOf(int frame) => StartOf(frame) + _frames[frame].Visualisation;

    /// <summary>Gets L_visu by Eq. (7) from the true times, ms.</summary>
    public double VisuMsOf(SimulatedMoment moment) => (moment.Middle - StartOf(moment.Frame)).TotalMilliseconds;

    /// <summary>Gets the picture as measured by a camera that reads both codes without error. The headset's code has a resolution of 1 ms.</summary>
    public MeasuredPicture Measured(SimulatedMoment moment)
    {
        var row = Rows[moment.Frame];
        var fraction = row.FrameStart.SinceEpoch.Ticks % TimeSpan.TicksPerMillisecond / (double)TimeSpan.TicksPerMillisecond;
        // ControlCode.Read returns half a millisecond less than the time. This cancels the mean rounding error of the headset's code.
        return new MeasuredPicture(null, row.Vertices, row.RenderMs, VisuMsOf(moment) + fraction - 0.5);
    }

    /// <summary>Gets, for each frame, the share of its light that a picture receives, relative to the maximum for one frame.</summary>
    /// <param name="middle">Middle of the exposure of the evaluated row.</param>
    public IEnumerable<(int Frame, double Share)> LightOf(SimulatedMoment moment, ControlTime middle)
    {
        var half = TimeSpan.FromMilliseconds(moment.ExposureMs / 2);
        var lit = TimeSpan.FromMilliseconds(_settings.LitMs / 2);
        for (var frame = Math.Max(0, moment.Frame - 3); frame < Math.Min(_frames.Count, moment.Frame + 4); frame++)
        {
            if (IsReplaced(frame)) continue;
            var from = Later(middle - half, LightOf(frame) - lit);
            var to = Earlier(middle + half, LightOf(frame) + lit);
            if (to > from) yield return (frame, (to - from).TotalMilliseconds / Math.Min(moment.ExposureMs, _settings.LitMs));
        }
    }

    SimulatedMoment MomentOf(int picture, RandomStream random)
    {
        var frame = Margin + picture * _framesPerPicture + (int)(random.Next() * _framesPerPicture);
        while (IsReplaced(frame)) frame++;
        var exposure = 1 + (_settings.ExposureMs - 1) * random.Next();
        var overlap = _settings.LitMs + exposure - 2 * MinLight * Math.Min(_settings.LitMs, exposure);
        return new SimulatedMoment(LightOf(frame) + TimeSpan.FromMilliseconds(overlap * (random.Next() - 0.5)), exposure, frame);
    }

    // The pictures of a video are taken at a fixed rate, also while the display is dark. Their exposures are equal.
    IEnumerable<SimulatedMoment> Video(double picturesPerSecond, RandomStream random)
    {
        var start = LightOf(Margin) + TimeSpan.FromMilliseconds(RefreshMs * random.Next());
        var frame = Margin;
        for (var picture = 0; picture < _settings.Pictures; picture++)
        {
            var middle = start + TimeSpan.FromSeconds(picture / picturesPerSecond);
            for (var next = frame + 1; next < _frames.Count - 1 && LightOf(next) < middle + TimeSpan.FromMilliseconds(RefreshMs / 2); next++)
                if (!IsReplaced(next)) frame = next;
            yield return new SimulatedMoment(middle, _settings.ExposureMs, frame);
        }
    }

    bool IsReplaced(int frame) => frame + 1 < _frames.Count && _frames[frame].IsReplacedBy(_frames[frame + 1]);

    int VerticesOf(int frame, int frames)
    {
        if (_settings.LoadSteps == 0) return OrdinaryVertices;
        var step = (int)((long)frame * (_settings.LoadSteps + 1) / frames);
        return (int)((long)_settings.MaxVertices * step / _settings.LoadSteps);
    }

    static ControlTime Earlier(ControlTime a, ControlTime b) => a < b ? a : b;

    static ControlTime Later(ControlTime a, ControlTime b) => a > b ? a : b;
}

/// <summary>The true times of a simulated picture.</summary>
/// <param name="Middle">Control time at the middle of the exposure, for the row of the headset's code.</param>
/// <param name="ExposureMs">Exposure time, ms.</param>
/// <param name="Frame">Index of the frame that is lit at that time.</param>
readonly record struct SimulatedMoment(ControlTime Middle, double ExposureMs, int Frame);
