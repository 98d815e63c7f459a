namespace UnityEditor;

public enum ApiCompatibilityLevel
{
    NET_Standard = 6,
    NET_Unity_4_8 = 3,
}
