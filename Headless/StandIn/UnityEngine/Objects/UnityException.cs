namespace UnityEngine;

/// <summary>Thrown when Unity's API is used in an invalid way.</summary>
sealed class UnityException : SystemException
{
    internal UnityException(string message) : base(message) { }
}
