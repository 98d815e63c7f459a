namespace UnityEngine.Events;

/// <summary>Kind of argument of a serialised call.</summary>
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
