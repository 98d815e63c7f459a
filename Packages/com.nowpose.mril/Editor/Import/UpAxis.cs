namespace Nowpose.Editor.Import
{
    /// <summary>The axis of a model file that points up, as the file itself says.</summary>
    enum UpAxis
    {
        X,
        Y,
        Z,
    }
}
