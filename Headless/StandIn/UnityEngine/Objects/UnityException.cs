using System;

namespace UnityEngine;

/// <summary>The engine's exception for invalid use.</summary>
sealed class UnityException : SystemException
{
    internal UnityException(string message) : base(message) { }
}
