namespace UnityEngine;

public sealed class GUIStyle
{
    public GUIStyle() { }
}
