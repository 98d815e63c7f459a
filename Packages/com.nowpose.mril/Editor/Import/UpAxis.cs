namespace Nowpose.Editor.Import
{
    /// <summary>The up axis that a model file specifies.</summary>
    enum UpAxis
    {
        X,
        Y,
        Z,
    }
}
