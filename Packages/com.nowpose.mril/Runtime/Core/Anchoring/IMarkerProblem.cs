namespace Nowpose.Anchoring
{
    /// <summary>A source of markers that can report why it has none.</summary>
    public interface IMarkerProblem
    {
        /// <summary>The problem in one line; null without a problem. The same object as long as the text is the same.</summary>
        string Problem { get; }
    }
}
