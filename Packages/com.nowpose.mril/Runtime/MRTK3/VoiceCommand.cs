using System;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Mrtk3
{
    /// <summary>A phrase to recognise, and the action that it triggers.</summary>
    [Serializable]
    public sealed class VoiceCommand
    {
        [SerializeField, Tooltip("Phrase to recognise. Use two words or more, because single words are often recognised by mistake.")]
        string _keyword = "";

        [SerializeField, Tooltip("Called when the phrase is recognised.")]
        UnityEvent _onHeard = new UnityEvent();

        public string Keyword => _keyword;

        public UnityEvent OnHeard => _onHeard;
    }
}
