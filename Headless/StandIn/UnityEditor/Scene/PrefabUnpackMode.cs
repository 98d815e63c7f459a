namespace UnityEditor;

public enum PrefabUnpackMode
{
    OutermostRoot = 0,
    Completely = 1,
}
