namespace UnityEditor;

public enum ApiCompatibilityLevel
{
    NET_2_0 = 1,
    NET_2_0_Subset = 2,
    NET_4_6 = 3,
    NET_Web = 4,
    NET_Micro = 5,
    NET_Standard_2_0 = 6,
    NET_Standard = 6,
    NET_Unity_4_8 = 3,
}
