using System;
using System.Reflection;

namespace UnityEngine;

/// <summary>Calls one method that has an argument; otherwise like <see cref="MessageCall"/>.</summary>
abstract class MessageCall<T>
{
    internal abstract void Invoke(MonoBehaviour target, T argument);

    internal static MessageCall<T> To(Type type, MethodInfo method) =>
        method == null ? null : (MessageCall<T>)Activator.CreateInstance(typeof(Of<>).MakeGenericType(typeof(T), type), method);

    sealed class Of<TScript> : MessageCall<T> where TScript : MonoBehaviour
    {
        readonly Action<TScript, T> _call;

        public Of(MethodInfo method) => _call = (Action<TScript, T>)method.CreateDelegate(typeof(Action<TScript, T>));

        internal override void Invoke(MonoBehaviour target, T argument) => _call((TScript)target, argument);
    }
}
