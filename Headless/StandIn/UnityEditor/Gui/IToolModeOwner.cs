namespace UnityEditor;

/// <summary>Used only as a base of <see cref="Editor"/>.</summary>
interface IToolModeOwner
{
}
