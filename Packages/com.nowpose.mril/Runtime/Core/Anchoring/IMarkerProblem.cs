namespace Nowpose.Anchoring
{
    /// <summary>A source of markers that knows why it tells of none.</summary>
    public interface IMarkerProblem
    {
        /// <summary>In one line; null when nothing is wrong. The same object while it says the same.</summary>
        string Problem { get; }
    }
}
