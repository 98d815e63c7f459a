namespace UnityEngine;

/// <summary>Thrown when a member of a destroyed object is accessed.</summary>
sealed class MissingReferenceException : SystemException
{
    internal MissingReferenceException(string message) : base(message) { }
}
