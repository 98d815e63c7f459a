using System;

namespace UnityEngine;

/// <summary>Something of a destroyed object was asked for.</summary>
sealed class MissingReferenceException : SystemException
{
    internal MissingReferenceException(string message) : base(message) { }
}
