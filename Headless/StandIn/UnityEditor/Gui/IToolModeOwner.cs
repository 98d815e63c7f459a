namespace UnityEditor;

/// <summary>Only for the bases of <see cref="Editor"/>.</summary>
interface IToolModeOwner
{
}
