using Nowpose.Cli.Replay;

namespace Nowpose.Cli.Recommend;

/// <summary>Collects the errors of a run separately for each half of the recording.</summary>
sealed class HalfErrors(IReadOnlyList<(string Name, string Unit)> axes)
{
    readonly ReplayErrors[] _halves = [new(axes), new(axes)];

    public void Add(Half half, ScoredValue value) => _halves[(int)half].Add(value);

    /// <exception cref="InputException">No frame of a half was scored.</exception>
    /// <exception cref="OperationCanceledException">The run was cancelled, so the errors are incomplete.</exception>
    public Trial Trial(string path, string predictor, CancellationToken cancellation)
    {
        cancellation.ThrowIfCancellationRequested();
        if (_halves.Any(half => half.Frames == 0)) throw new InputException(RecommendMessages.TooShort(path));
        return new Trial(predictor, _halves[0].Result(path, predictor), _halves[1].Result(path, predictor));
    }
}
