using System.Collections.Generic;
using MixedReality.Toolkit;
using MixedReality.Toolkit.Subsystems;
using Nowpose.Unity;
using UnityEngine;

namespace Nowpose.Mrtk3
{
    /// <summary>Does by voice what a menu does by hand, also while the menu is hidden, wherever the wearer looks.</summary>
    /// <remarks>
    /// Asks MRTK3's keyword recognition as soon as it runs. The keyword of a button is heard only while the button is there:
    /// those of a hand menu would need the hand.
    /// </remarks>
    [AddComponentMenu("Nowpose/Voice Commands")]
    [DisallowMultipleComponent]
    public sealed class VoiceCommands : MonoBehaviour
    {
        [SerializeField, Tooltip("What is said, and what it does. None: nothing is listened for.")]
        List<VoiceCommand> _commands = new List<VoiceCommand>();

        /// <summary>Speech starts some seconds after the scene, or never: without microphone, or where its package is missing.</summary>
        const float PatienceSeconds = 10;

        IKeywordRecognitionSubsystem _recognition;
        float _since;
        bool _isTold;

        public IReadOnlyList<VoiceCommand> Commands => _commands;

        /// <summary>Whether keywords are listened for.</summary>
        public bool IsListening => _recognition != null && _recognition.running;

        void OnEnable()
        {
            _since = Time.unscaledTime;
            _isTold = false;
        }

        void Update()
        {
            if (IsListening) return;
            Leave();
            var running = XRSubsystemHelpers.KeywordRecognitionSubsystem;
            if (running != null) Listen(running);
            else if (!_isTold && Time.unscaledTime - _since > PatienceSeconds)
            {
                _isTold = true;
                ConsoleLog.Say(this, "voice commands '" + name + "': no keyword recognition runs; the menu does the same");
            }
        }

        void OnDisable() => Leave();

        void Listen(IKeywordRecognitionSubsystem recognition)
        {
            _recognition = recognition;
            foreach (var command in _commands)
                if (command.Keyword.Length > 0) recognition.CreateOrGetEventForKeyword(command.Keyword).AddListener(command.OnHeard.Invoke);
        }

        // Only what is its own: somebody else may listen for the same word.
        void Leave()
        {
            if (_recognition == null) return;
            foreach (var command in _commands)
                if (command.Keyword.Length > 0) _recognition.CreateOrGetEventForKeyword(command.Keyword).RemoveListener(command.OnHeard.Invoke);
            _recognition = null;
        }
    }
}
