namespace UnityEngine;

/// <summary>Thrown when Unity's API is used in an invalid way.</summary>
sealed class UnityException : SystemException
{
    internal UnityException(string message) : base(message) { }
}

/// <summary>Thrown when a member of a destroyed object is accessed.</summary>
sealed class MissingReferenceException : SystemException
{
    internal MissingReferenceException(string message) : base(message) { }
}
