using System;

namespace UnityEngine;

/// <summary>What the engine throws at a misuse.</summary>
sealed class UnityException : SystemException
{
    internal UnityException(string message) : base(message) { }
}
