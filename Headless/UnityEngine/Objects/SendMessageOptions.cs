namespace UnityEngine;

public enum SendMessageOptions
{
    RequireReceiver = 0,
    DontRequireReceiver = 1,
}
