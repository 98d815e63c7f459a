namespace UnityEngine;

[Flags]
public enum HideFlags
{
    None = 0,
    HideInHierarchy = 1,
    HideInInspector = 2,
    DontSave = 52,
    HideAndDontSave = 61,
}
