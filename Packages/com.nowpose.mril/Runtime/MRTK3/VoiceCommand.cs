using System;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Mrtk3
{
    /// <summary>A keyword and its action.</summary>
    [Serializable]
    public sealed class VoiceCommand
    {
        [SerializeField, Tooltip("What is said. Two words or more: single ones are heard where nobody said them.")]
        string _keyword = "";

        [SerializeField, Tooltip("What it does.")]
        UnityEvent _onHeard = new UnityEvent();

        public string Keyword => _keyword;

        public UnityEvent OnHeard => _onHeard;
    }
}
