using System;

namespace UnityEngine;

/// <summary>A member of a destroyed object was accessed.</summary>
sealed class MissingReferenceException : SystemException
{
    internal MissingReferenceException(string message) : base(message) { }
}
