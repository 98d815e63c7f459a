using Nowpose.Prediction;

namespace Nowpose.Cli.Studies;

/// <summary>Feeds the samples of one axis to a predictor in virtual time, as a headset would receive them.</summary>
public static class PredictionStudy
{
    /// <summary>Runs all phases and evaluates them together, in the unit of the motion.</summary>
    public static ErrorComparison Run(AxisMotion motion, StudySettings settings, Func<JointPredictor> newPredictor)
    {
        var errors = new ErrorCollector();
        for (var phase = 0; phase < settings.Phases; phase++)
            foreach (var frame in Frames(motion, settings, newPredictor(), phase))
                errors.Add(frame.Held - frame.Truth, frame.Predicted - frame.Truth);
        return errors.Result();
    }

    /// <summary>Gets the scored frames of one run.</summary>
    /// <param name="phase">Index of the run.</param>
    public static IEnumerable<StudyFrame> Frames(AxisMotion motion, StudySettings settings, JointPredictor predictor, int phase)
    {
        var random = new Random(HashCode(settings.Seed, phase));
        var firstFrame = random.NextDouble() / settings.FrameRateHz;
        var underWay = new SampleStream(motion, settings, random);
        var displayed = double.NaN;
        for (var i = 0; ; i++)
        {
            var time = firstFrame + i / settings.FrameRateHz;
            if (time > motion.Seconds) yield break;
            underWay.Deliver(time, predictor, displayed);
            displayed = time + settings.LatencyError;
            var predicted = predictor.At(displayed).Position;
            if (time >= settings.WarmUp) yield return new StudyFrame(time, motion.At(time), predictor.Hold, predicted);
        }
    }

    // Mixes seed and phase, so that consecutive seeds produce independent sequences. .NET's own HashCode returns different values in each process.
    static int HashCode(int seed, int phase) => unchecked((int)(((uint)seed * 2654435761u + (uint)phase) * 2246822519u >> 1));
}
