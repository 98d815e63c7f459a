namespace UnityEngine;

public enum RuntimePlatform
{
    WindowsPlayer = 2,
    Android = 11,
    WSAPlayerARM = 20,
}
