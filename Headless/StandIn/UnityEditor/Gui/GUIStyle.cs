namespace UnityEngine;

public sealed class GUIStyle
{
    internal GUIStyle() { }
}
