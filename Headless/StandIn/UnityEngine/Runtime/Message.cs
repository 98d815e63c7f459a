namespace UnityEngine;

/// <summary>Messages without arguments: methods of scripts that Unity calls by name.</summary>
enum Message
{
    Awake,
    OnEnable,
    Update,
    LateUpdate,
    OnDisable,
    OnDestroy,
    OnTransformParentChanged,
    OnApplicationQuit,
    Count,
}
