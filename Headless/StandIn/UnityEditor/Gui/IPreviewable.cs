namespace UnityEditor;

/// <summary>Base interface of <see cref="Editor"/>, as in Unity. Not used here.</summary>
interface IPreviewable
{
}
