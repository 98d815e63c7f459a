using Nowpose.Cli.Demo;
using Nowpose.Cli.Demo.Paper;
using Nowpose.Cli.Demo.Virtual;
using Nowpose.Cli.Figures.Model;
using Nowpose.Cli.Studies;
using Nowpose.Gateway.Options;
using Nowpose.Latency;
using Nowpose.Simulation;

namespace Nowpose.Cli.Figures.Swing;

/// <summary>
/// Figs 16 to 18: the paper's proof of concept, a virtual gripper on a swinging robot. Plays the swing through the complete processing chain in
/// virtual time: sampling and time stamps in the control system, a simulated network, clock synchronisation by RANSAC, L_visu from pictures of the
/// simulated display, prediction and forward kinematics.
/// </summary>
sealed class SwingRuns : IFigureStudy
{
    static readonly SwingScenario[] Scenarios = [SwingScenario.Standard, SwingScenario.Cold];

    readonly FigureSettings _settings;
    readonly CancellationToken _cancel;
    readonly Lazy<LatencyProfile> _profile;
    readonly StudyFrame[,,][] _frames;
    readonly YoubotSwing[] _swings = [.. Scenarios.Select(scenario => scenario.SwingAfter(0))];

    /// <param name="cancel">Ends the measurement of the display, which takes longer than the other work.</param>
    public SwingRuns(FigureSettings settings, CancellationToken cancel)
    {
        (_settings, _cancel) = (settings, cancel);
        _profile = new Lazy<LatencyProfile>(() => settings.Profile ?? Measure());
        _frames = new StudyFrame[Scenarios.Length, Predicted.Count, settings.Phases][];
        Work = [.. from s in Enumerable.Range(0, Scenarios.Length)
            from p in Enumerable.Range(0, Predicted.Count)
            from run in Enumerable.Range(0, settings.Phases)
            select (Action)(() => _frames[s, p, run] = Play(s, Predicted[p], run))];
    }

    /// <summary>The evaluated predictors, starting with the paper's predictor.</summary>
    public static IReadOnlyList<string> Predicted { get; } = [PaperScenario.Predictor, .. FigureSettings.OurPredictors];

    /// <summary>Conditions of all runs. They give an L of 100 to 150 ms, as in the paper's plant.</summary>
    static DemoSettings Conditions { get; } = new()
    {
        Network = NetworkProfile.Wifi, Acquisition = new MillisecondRange(55, 105), VisualisationMs = 40,
    };

    public YoubotSwing Swing => _swings[0];

    public IReadOnlyList<Action> Work { get; }

    /// <summary>The profile of the display. It is measured when it is first read.</summary>
    public LatencyProfile Profile => _profile.Value;

    /// <summary>The frames for the figures: those of the standard scenario, and those of all scenarios.</summary>
    public SwingSet Set
    {
        get
        {
            SwingFrames[] all = [.. from s in Enumerable.Range(0, Scenarios.Length)
                from p in Enumerable.Range(0, Predicted.Count)
                select new SwingFrames(Predicted[p], Scenarios[s], _swings[s], [.. Enumerable.Range(0, _settings.Phases).Select(run => _frames[s, p, run])])];
            return new SwingSet([.. all.Where(frames => frames.Scenario == SwingScenario.Standard)], all);
        }
    }

    public IEnumerable<Figure> Figures()
    {
        var set = Set;
        return [Figure16.Of(set), Figure17.Of(set), Figure18.Of(set)];
    }

    LatencyProfile Measure()
    {
        var calibration = PaperCalibration.Of(
            PaperScenario.Of(Conditions with { Seed = _settings.Seed }, Swing), _settings.PicturesPerLoad, _cancel, showsProgress: false);
        _cancel.ThrowIfCancellationRequested();
        return calibration.Profile;
    }

    StudyFrame[] Play(int scenario, string predictor, int run)
    {
        // In each run, the swing has a different phase relative to samples and frames.
        var swing = Scenarios[scenario].SwingAfter(PaperScenario.SamplingMs / 1000 * run / _settings.Phases);
        var given = Conditions with { Seconds = swing.Motion.Seconds, Seed = _settings.Seed * 1000 + run, Profile = Profile };
        var settings = PaperScenario.Of(given, swing) with { Predictor = predictor };
        return new PaperRun(run + 1, VirtualStage.Play(settings, hasScene: false), swing).Swings?.Phases.Single()
            ?? throw new DemoFailedException(FigureErrors.NoSwing(run + 1, predictor));
    }
}
