using Nowpose.Anchoring;
using Nowpose.Kinematics;

namespace Nowpose.Cli.Replay;

/// <summary>Collects the errors of hold and of the prediction for the position or rotation of a body, and computes the results.</summary>
sealed class BodyError
{
    /// <summary>An object counts as moving if it moves within this time before and after the display time, s.</summary>
    const double HalfInterval = 0.005;

    /// <summary>Minimum speeds of a moving object, m/s and rad/s.</summary>
    const double MinSpeed = 0.001, MinTurning = 0.005;

    readonly List<double> _predicted = [];
    double _squares;
    double _heldSquares;

    /// <param name="poseAt">Returns the true pose of the object at a time, s.</param>
    public static bool IsMoving(Func<double, RigidTransform> poseAt, double time)
    {
        var (before, after) = (poseAt(time - HalfInterval), poseAt(time + HalfInterval));
        return before.DistanceTo(after) > 2 * HalfInterval * MinSpeed || before.AngleTo(after) > 2 * HalfInterval * MinTurning;
    }

    public int Count => _predicted.Count;

    /// <summary>Adds the absolute errors of one frame.</summary>
    public void Add(double held, double predicted)
    {
        _heldSquares += held * held;
        _squares += predicted * predicted;
        _predicted.Add(predicted);
    }

    /// <param name="scale">Factor that converts the unit of the added errors to the unit of the result.</param>
    public BodyReplayResult.ErrorSize Summary(double scale) => new(
        scale * Math.Sqrt(_heldSquares / _predicted.Count), scale * Math.Sqrt(_squares / _predicted.Count),
        scale * Quantile.Of(_predicted, 0.95), scale * _predicted.Max());
}
