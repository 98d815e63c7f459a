namespace UnityEngine;

/// <summary>What the engine calls on a script by its name, without an argument.</summary>
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
