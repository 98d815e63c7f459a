namespace Nowpose.Editor.Import
{
    /// <summary>Up axis of a model file.</summary>
    enum UpAxis
    {
        X,
        Y,
        Z,
    }
}
