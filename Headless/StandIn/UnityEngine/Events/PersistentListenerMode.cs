namespace UnityEngine.Events;

/// <summary>Kind of argument of a persistent call.</summary>
enum PersistentListenerMode
{
    EventDefined,
    Void,
    Object,
    Int,
    Float,
    String,
    Bool,
}
