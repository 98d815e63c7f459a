namespace UnityEngine;

/// <summary>Messages without arguments that the engine calls on scripts by name.</summary>
enum Message
{
    Awake,
    OnEnable,
    Update,
    LateUpdate,
    OnDisable,
    OnDestroy,
    OnApplicationQuit,
    Count,
}
