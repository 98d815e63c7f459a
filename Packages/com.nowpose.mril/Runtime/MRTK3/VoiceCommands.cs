using System.Collections.Generic;
using MixedReality.Toolkit;
using MixedReality.Toolkit.Subsystems;
using Nowpose.Unity;
using Nowpose.Unity.Session;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Mrtk3
{
    /// <summary>Does by voice what a menu does by hand, also while the menu is hidden, wherever the wearer looks.</summary>
    /// <remarks>
    /// Registers its keywords with MRTK3's keyword recognition as soon as that runs, and unregisters them when it is disabled. A keyword
    /// that something else had registered before stays registered. The keyword of a button is heard only while the button is there:
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

        // The event that each keyword was registered with, and the keywords that were not registered before.
        readonly Dictionary<string, UnityEvent> _registered = new Dictionary<string, UnityEvent>();
        readonly HashSet<string> _own = new HashSet<string>();
        IKeywordRecognitionSubsystem _recognition;
        float _since;
        bool _isTold, _isUnsupported;

        public IReadOnlyList<VoiceCommand> Commands => _commands;

        /// <summary>Whether keywords are listened for.</summary>
        public bool IsListening => _recognition != null && _recognition.running;

        void OnEnable()
        {
            _since = Time.unscaledTime;
            _isTold = false;
            _isUnsupported = false;
        }

        void Update()
        {
            if (_isUnsupported) return;
            if (!IsListening) Find();
            if (IsListening) Register();
        }

        void OnDisable() => Unregister();

        void Find()
        {
            Unregister();
            _recognition = XRSubsystemHelpers.KeywordRecognitionSubsystem;
            if (_recognition != null || _isTold || Time.unscaledTime - _since <= PatienceSeconds) return;
            _isTold = true;
            ConsoleLog.Say(this, "voice commands '" + name + "': no keyword recognition runs; the menu does the same");
        }

        // Checked in each frame: another component that unregisters the same keyword takes the listeners of all away.
        void Register()
        {
            var known = _recognition.GetAllKeywords();
            if (known == null)
            {
                // MRTK3's recognition for Windows on another platform: it logs an error for each call.
                ConsoleLog.Warn(this, "voice commands '" + name + "': keyword recognition is not supported on this platform; the menu does the same");
                _recognition = null;
                _isUnsupported = true;
                return;
            }
            foreach (var command in _commands)
            {
                var keyword = command.Keyword;
                if (keyword.Length == 0) continue;
                var isKnown = known.TryGetValue(keyword, out var current);
                if (isKnown && _registered.TryGetValue(keyword, out var registered) && registered == current) continue;
                if (!isKnown) _own.Add(keyword);
                Register(keyword);
            }
        }

        void Register(string keyword)
        {
            var heard = _recognition.CreateOrGetEventForKeyword(keyword);
            _registered[keyword] = heard;
            foreach (var command in _commands)
                if (command.Keyword == keyword) heard.AddListener(command.OnHeard.Invoke);
        }

        void Unregister()
        {
            foreach (var command in _commands)
                if (_registered.TryGetValue(command.Keyword, out var heard)) heard.RemoveListener(command.OnHeard.Invoke);
            foreach (var keyword in _own) _recognition.RemoveKeyword(keyword);
            _registered.Clear();
            _own.Clear();
            _recognition = null;
        }
    }
}
