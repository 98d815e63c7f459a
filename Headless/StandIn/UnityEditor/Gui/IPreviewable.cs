namespace UnityEditor;

/// <summary>Base interface of <see cref="Editor"/>, as in Unity. The stand-in does not use it.</summary>
interface IPreviewable
{
}
