using System.Reflection;

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

/// <summary>Calls one method on any object of one class, without allocation and as fast as a delegate.</summary>
abstract class MessageCall
{
    internal abstract void Invoke(MonoBehaviour target);

    internal static MessageCall To(Type type, MethodInfo method) =>
        method == null ? null : (MessageCall)Activator.CreateInstance(typeof(Of<>).MakeGenericType(type), method);

    sealed class Of<TScript> : MessageCall where TScript : MonoBehaviour
    {
        readonly Action<TScript> _call;

        public Of(MethodInfo method) => _call = (Action<TScript>)method.CreateDelegate(typeof(Action<TScript>));

        internal override void Invoke(MonoBehaviour target) => _call((TScript)target);
    }
}
